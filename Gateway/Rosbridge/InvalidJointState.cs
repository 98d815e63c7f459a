using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using static Nowpose.Frames.InvalidTransform;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Reads the joint names of invalid joint states and set-points, and finds the joint with an invalid position.</summary>
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
        var state = BodyOf(utf8);
        return state?["name"] is JArray names ? (NamesIn(names), TroubleIn(names, state[Field] as JArray)) : ([], null);
    }

    /// <summary>Returns the names of the joints in a message with set-points.</summary>
    /// <param name="utf8">The complete message.</param>
    public static string[] ReadPlannedNames(ReadOnlySpan<byte> utf8) => BodyOf(utf8)?["joint_names"] is JArray names ? NamesIn(names) : [];

    static JObject BodyOf(ReadOnlySpan<byte> utf8)
    {
        try
        {
            return JObject.Parse(Encoding.UTF8.GetString(utf8))["msg"] as JObject;
        }
        catch (JsonException)
        {
            return null;
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
            if (!IsFinite(values[i]))
                return $"{Field} of joint {InputException.OneLine(names[i].ToString(), ProtocolLimits.NameLength)} is {Shown(values[i])}";
        }

        return null;
    }
}
