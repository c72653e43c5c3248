/// Cancellation of a filter by the user: MeshLab has a progress bar without a way
/// to cancel.
#pragma once

#include <QObject>
#include <QPointer>

class QPushButton;

namespace fieldfab::meshlab {

/// During its lifetime, shows a Cancel button in the status bar of the main window, beside the
/// progress bar; the Escape key does the same. Filters out all other input, by which a user could
/// start a second filter on the same layers or close the window. Does nothing without a window
/// (meshlabserver).
class CancelButton : public QObject {
  Q_OBJECT
 public:
  CancelButton();
  ~CancelButton() override;
  /// Processes events of the window, and returns whether the user wants to stop.
  bool pressed();

 protected:
  bool eventFilter(QObject* receiver, QEvent* event) override;

 private:
  QPointer<QPushButton> button_;
  bool pressed_ = false;
};

}  // namespace fieldfab::meshlab
