using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Reads the joint names of an invalid joint state, and finds the joint with an invalid position.</summary>
static class InvalidJointState
{
    // Only positions are checked, because a velocity or an effort may be absent, null or NaN.
    const string Field = "position";

    /// <summary>
    /// Returns the names of the joints, and a description of the first position that is not a finite number, such as "position of joint a is
    /// null"; null if there is none.
    /// </summary>
    /// <param name="utf8">The complete message.</param>
    public static (string[] Names, string Trouble) Read(ReadOnlySpan<byte> utf8)
    {
        try
        {
            if (JObject.Parse(Encoding.UTF8.GetString(utf8))["msg"] is not JObject state || state["name"] is not JArray names) return ([], null);
            return (NamesIn(names), TroubleIn(names, state[Field] as JArray));
        }
        catch (JsonException)
        {
            return ([], null);
        }
    }

    static string[] NamesIn(JArray names) =>
    [
        .. names.Where(name => name.Type == JTokenType.String).Select(name => (string)name)
            .Where(name => name.Length is > 0 and <= ProtocolLimits.NameLength).Distinct().Take(ProtocolLimits.Joints),
    ];

    static string TroubleIn(JArray names, JArray values)
    {
        for (var i = 0; i < Math.Min(names.Count, values?.Count ?? 0); i++)
        {
            if (!ReceivedValue.IsFinite(values[i]))
                return $"{Field} of joint {ReceivedValue.Name(names[i].ToString())} is {ReceivedValue.Text(values[i])}";
        }

        return null;
    }
}
