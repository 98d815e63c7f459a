using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol.Cell;
using static Nowpose.Gateway.Rosbridge.ReceivedValue;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Finds the frame or the signal that makes a message on /tf, /tf_static or /signals invalid, and describes it with its value.</summary>
static class InvalidCellMessage
{
    static readonly string[] Axes = ["x", "y", "z"], Components = ["x", "y", "z", "w"];

    /// <summary>
    /// Describes the first invalid frame or signal of a message, for example "frame box has a rotation with the norm 1.02; it must be 1 within
    /// 0.001". Returns null if none is found, or if the reason does not concern a single frame or signal.
    /// </summary>
    /// <param name="utf8">The complete message, which was dropped for <paramref name="reason"/>.</param>
    public static string Read(ReadOnlySpan<byte> utf8, DropReason reason)
    {
        if (!IsDescribed(reason)) return null;
        try
        {
            var message = JObject.Parse(Encoding.UTF8.GetString(utf8))["msg"] as JObject;
            return message?["transforms"] is JArray transforms ? InTransforms(transforms, reason) : InSignals(message, reason);
        }
        catch (JsonException)
        {
            return null;
        }
    }

    static bool IsDescribed(DropReason reason) => reason
        is DropReason.NotUnitQuaternion or DropReason.NotFinite or DropReason.OwnParent or DropReason.DuplicateName or DropReason.StampZero;

    static string InTransforms(JArray transforms, DropReason reason)
    {
        var children = new HashSet<string>();
        foreach (var one in transforms.OfType<JObject>())
        {
            var child = one["child_frame_id"] is { Type: JTokenType.String } name ? (string)name : "";
            var trouble = reason switch
            {
                DropReason.OwnParent => child == one.SelectToken("header.frame_id")?.ToString() ? CellMessageFaults.OwnParent : null,
                DropReason.DuplicateName => children.Add(child) ? null : "occurs twice as child_frame_id",
                DropReason.StampZero => IsZero(one.SelectToken("header.stamp")) ? CellMessageFaults.StampZero : null,
                DropReason.NotFinite => NotFinite(one["transform"] as JObject),
                _ => Norm(one.SelectToken("transform.rotation") as JObject),
            };
            if (trouble != null) return $"frame {Name(child)} {trouble}";
        }

        return null;
    }

    static string InSignals(JObject message, DropReason reason)
    {
        if (message?["name"] is not JArray names) return null;
        var known = new HashSet<string>();
        for (var i = 0; i < names.Count; i++)
        {
            var name = names[i].ToString();
            if (reason == DropReason.DuplicateName && !known.Add(name)) return CellMessageFaults.SignalTwice(Name(name));
            if (reason == DropReason.NotFinite && message["value"] is JArray values && i < values.Count && !IsFinite(values[i]))
                return CellMessageFaults.SignalValue(Name(name), Text(values[i]));
        }

        return null;
    }

    static string NotFinite(JObject transform)
    {
        foreach (var (part, fields) in new[] { ("translation", Axes), ("rotation", Components) })
            foreach (var field in fields)
                if (transform?[part] is JObject numbers && numbers[field] is { } value && !IsFinite(value)) return $"has {part}.{field} {Text(value)}";
        return null;
    }

    static string Norm(JObject rotation)
    {
        var components = Array.ConvertAll(Components, field => rotation?[field] is { } value && IsFinite(value) ? (double)value : 0);
        var norm = Math.Sqrt(components.Sum(component => component * component));
        var (x, y, z, w) = (components[0], components[1], components[2], components[3]);
        return FrameTransform.TryNormalise(ref x, ref y, ref z, ref w) ? null : CellMessageFaults.Norm(norm, FrameTransform.NormTolerance);
    }

    static bool IsZero(JToken stamp) => stamp is JObject time && time.PropertyValues().All(part => part.Type == JTokenType.Integer && part.ToString() == "0");
}
