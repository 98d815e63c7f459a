using System.Text.Json.Serialization;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The fields of a message type, as the ROS type rosapi/TypeDef.</summary>
/// <param name="ArrayLengths">Array length of each field: −1 for a single value, 0 for an array of any length.</param>
/// <param name="Examples">Empty value of each field.</param>
sealed record TypeDefinition(
    [property: JsonPropertyName("type")] string Type,
    [property: JsonPropertyName("fieldnames")] string[] FieldNames,
    [property: JsonPropertyName("fieldtypes")] string[] FieldTypes,
    [property: JsonPropertyName("fieldarraylen")] int[] ArrayLengths,
    [property: JsonPropertyName("examples")] string[] Examples,
    [property: JsonPropertyName("constnames")] string[] ConstantNames,
    [property: JsonPropertyName("constvalues")] string[] ConstantValues);
