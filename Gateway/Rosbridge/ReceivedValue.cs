using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Formats values and names from an invalid message on one line.</summary>
static class ReceivedValue
{
    const int MaxLength = 32;

    public static bool IsFinite(JToken value) => value.Type == JTokenType.Integer || (value.Type == JTokenType.Float && double.IsFinite((double)value));

    /// <summary>Returns a value as sent by the client, for example NaN without the quotation marks that Newtonsoft.Json adds.</summary>
    public static string Text(JToken value) =>
        InputException.OneLine(value.Type == JTokenType.Float ? value.ToString() : value.ToString(Formatting.None), MaxLength);

    public static string Name(string name) => InputException.OneLine(name, ProtocolLimits.NameLength);
}
