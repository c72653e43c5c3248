#include "parameters.h"

#include "meshlab.h"

namespace fieldfab::meshlab {

QString text_of(const std::string& utf8) { return QString::fromUtf8(utf8.c_str(), static_cast<int>(utf8.size())); }

void show_parameters(const std::vector<Parameter>& parameters, const MeshDocument* document, RichParameterList& list) {
  using Kind = Parameter::Kind;
  for (const Parameter& row : parameters) {
    const QString name = text_of(row.name), label = text_of(row.label), help = text_of(row.help);
    const auto* number = std::get_if<double>(&row.value);
    const double value = number != nullptr ? *number : 0;
    const QString text = number != nullptr ? QString() : text_of(std::get<std::string>(row.value));
    QStringList choices;
    for (const std::string& choice : row.choices) choices << text_of(choice);
    switch (row.kind) {
      case Kind::length:
        list.addParam(LengthRow(name, static_cast<float>(value), static_cast<float>(row.least),
                                static_cast<float>(row.most), label, help));
        break;
      case Kind::number: list.addParam(RichFloat(name, static_cast<float>(value), label, help)); break;
      case Kind::whole: list.addParam(RichInt(name, static_cast<int>(value), label, help)); break;
      case Kind::yes_no: list.addParam(RichBool(name, value != 0, label, help)); break;
      case Kind::choice: list.addParam(RichEnum(name, static_cast<int>(value), choices, label, help)); break;
      case Kind::layer: list.addParam(layer_row(name, static_cast<std::size_t>(value), document, label, help)); break;
      case Kind::text: list.addParam(RichString(name, text, label, help)); break;
      case Kind::file: list.addParam(FileRow(name, text, choices, label, help)); break;
    }
  }
}

std::vector<Parameter> chosen_parameters(std::vector<Parameter> parameters, const MeshDocument* document,
                                         const RichParameterList& list) {
  using Kind = Parameter::Kind;
  for (Parameter& row : parameters) {
    const QString name = text_of(row.name);
    if (!list.hasParameter(name)) continue;
    switch (row.kind) {
      case Kind::length: row.value = static_cast<double>(list.getAbsPerc(name)); break;
      case Kind::number: row.value = static_cast<double>(list.getFloat(name)); break;
      case Kind::whole: row.value = static_cast<double>(list.getInt(name)); break;
      case Kind::yes_no: row.value = list.getBool(name) ? 1.0 : 0.0; break;
      case Kind::choice: row.value = static_cast<double>(list.getEnum(name)); break;
      case Kind::layer: row.value = static_cast<double>(chosen_layer(list, name, *document)); break;
      case Kind::text: row.value = list.getString(name).toUtf8().toStdString(); break;
      case Kind::file: row.value = list.getOpenFileName(name).toUtf8().toStdString(); break;
    }
  }
  return parameters;
}

}  // namespace fieldfab::meshlab
