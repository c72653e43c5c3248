#include "cancel_button.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <QPushButton>
#include <QStatusBar>

namespace fieldfab::meshlab {

CancelButton::CancelButton() {
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (auto* window = qobject_cast<QMainWindow*>(widget); window != nullptr && window->isVisible()) {
      button_ = new QPushButton(tr("Cancel (Esc)"));
      button_->setObjectName("FieldfabCancel");
      button_->setCursor(Qt::ArrowCursor);
      window->statusBar()->addPermanentWidget(button_);
      button_->show();
      connect(button_, &QPushButton::clicked, this, [this] { pressed_ = true; });
      qApp->installEventFilter(this);
      return;
    }
}

CancelButton::~CancelButton() {
  if (button_) qApp->removeEventFilter(this);
  delete button_;
}

bool CancelButton::pressed() {
  if (button_) QApplication::processEvents(QEventLoop::AllEvents, 20);
  return pressed_;
}

bool CancelButton::eventFilter(QObject* receiver, QEvent* event) {
  switch (event->type()) {
    case QEvent::KeyPress:
      if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) pressed_ = true;
      return true;
    case QEvent::Close:
      pressed_ = true;
      event->ignore();
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
      // A click reaches the window of the button first, as a QWindow, and then the button.
      return receiver->isWidgetType() && receiver != button_;
    case QEvent::KeyRelease:
    case QEvent::Shortcut:
    case QEvent::ShortcutOverride:
    case QEvent::Wheel:
    case QEvent::ContextMenu:
    case QEvent::DragEnter:
    case QEvent::Drop: return true;
    default: return false;
  }
}

}  // namespace fieldfab::meshlab
