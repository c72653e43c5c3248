/// How a user stops a filter: this version of MeshLab has a progress bar, but nothing to cancel with.
#pragma once

#include <QObject>
#include <QPointer>

class QPushButton;

namespace fieldfab::meshlab {

/// While it lives, a Cancel button stands in the main window's status bar, beside the progress bar; the Escape key does the same.
/// Everything else that a user does in the meantime is kept from MeshLab, which would begin a second filter on the same layers,
/// or close the window. Without a window (meshlabserver) it does nothing.
class CancelButton : public QObject {
  Q_OBJECT
 public:
  CancelButton();
  ~CancelButton() override;
  /// Lets the window live for a moment, and tells whether somebody wants to stop.
  bool pressed();

 protected:
  bool eventFilter(QObject* receiver, QEvent* event) override;

 private:
  QPointer<QPushButton> button_;
  bool pressed_ = false;
};

}  // namespace fieldfab::meshlab
