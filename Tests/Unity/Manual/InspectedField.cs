using UnityEngine;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>A field of a component or asset in the Inspector.</summary>
/// <param name="Label">Label in the Inspector. For a field of a list element, the label of the list comes first: "Fingers › Joint".</param>
/// <param name="Default">Value in a new component, as text.</param>
/// <param name="Type">Type of the field, or of the elements if the field is a list.</param>
/// <param name="Range">Range of the slider; null if the field has none.</param>
/// <param name="Tooltip">Tooltip; null if the field has none.</param>
sealed record InspectedField(string Label, string Default, Type Type, RangeAttribute Range, string Tooltip);
