using UnityEngine;

namespace Nowpose.Unity.Tests.Manual;

/// <param name="Label">Label in the Inspector; a field within a list follows the list's label, such as "Fingers › Joint".</param>
/// <param name="Default">Value in a new component, in words.</param>
/// <param name="Type">Type of the field, or of the elements of its list.</param>
/// <param name="Range">Null for no range.</param>
/// <param name="Tooltip">Null for no tooltip.</param>
sealed record InspectedField(string Label, string Default, Type Type, RangeAttribute Range, string Tooltip);
