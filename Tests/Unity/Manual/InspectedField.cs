using UnityEngine;

namespace Nowpose.Unity.Tests.Manual;

/// <param name="Label">As the Inspector shows it; within a list after the list's own, "Fingers › Joint".</param>
/// <param name="Default">What a new component has, in words.</param>
/// <param name="Type">Of the field, or of what its list holds.</param>
/// <param name="Range">Null for none.</param>
/// <param name="Tooltip">Null for none.</param>
sealed record InspectedField(string Label, string Default, Type Type, RangeAttribute Range, string Tooltip);
