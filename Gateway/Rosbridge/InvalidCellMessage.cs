using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using static Nowpose.Gateway.Rosbridge.ReceivedValue;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Describes an invalid transform or signal with its value. The text is the body of a message with only this transform or signal.</summary>
static class InvalidCellMessage
{
    static readonly string[] Axes = ["x", "y", "z"], Components = ["x", "y", "z", "w"];

    /// <summary>
    /// Describes the fault, for example "frame box has a rotation with the norm 1.02; it must be 1 within 0.001".
    /// </summary>
    /// <param name="name">Name of the frame or signal; empty if unknown.</param>
    /// <param name="kind"><see cref="CellKinds.Frame"/> or <see cref="CellKinds.Signal"/>.</param>
    public static string Describe(string body, string name, string kind, DropReason reason)
    {
        var what = $"{kind} {(name.Length == 0 ? CellMessageFaults.NoName : Name(name))}";
        var trouble = kind == CellKinds.Signal ? OfSignal(body, reason) : OfTransform(Parse(body)?.SelectToken("transforms[0]") as JObject, reason);
        return trouble == null ? $"{what}: {DropMessages.Of(reason)}" : $"{what} {trouble}";
    }

    static string OfTransform(JObject transform, DropReason reason) => reason switch
    {
        DropReason.OwnParent => CellMessageFaults.OwnParent,
        DropReason.DuplicateName => CellMessageFaults.ChildTwice,
        DropReason.StampZero => CellMessageFaults.StampZero,
        DropReason.NotFinite => Number(transform, value => !IsFinite(value)) is var (field, value) ? CellMessageFaults.Has(field, value) : null,
        DropReason.OutOfRange => Number(transform, value => IsFinite(value) && Math.Abs((double)value) > TransformsReader.MaxCoordinate) is var (field, value)
            ? CellMessageFaults.TooFar(field, value, TransformsReader.MaxCoordinate) : null,
        DropReason.NotUnitQuaternion => CellMessageFaults.Norm(Norm(transform), FrameTransform.NormTolerance),
        _ => null,
    };

    static string OfSignal(string body, DropReason reason) => reason switch
    {
        DropReason.DuplicateName => CellMessageFaults.Twice,
        DropReason.NotFinite => CellMessageFaults.Has("value", Value(body) is { } value ? Text(value) : ""),
        DropReason.WrongType when Value(body) is { Type: not (JTokenType.Integer or JTokenType.Float) } value => CellMessageFaults.NotANumber(Text(value)),
        _ => null,
    };

    static JToken Value(string body) => Parse(body)?.SelectToken("value[0]");

    // Returns the first number with a fault.
    static (string Field, string Value)? Number(JObject transform, Predicate<JToken> isWrong)
    {
        foreach (var (part, fields) in new[] { ("translation", Axes), ("rotation", Components) })
            foreach (var field in fields)
                if (transform?.SelectToken($"transform.{part}.{field}") is { } value && isWrong(value)) return ($"{part}.{field}", Text(value));
        return null;
    }

    static double Norm(JObject transform) => Math.Sqrt(Components.Sum(field =>
        transform?.SelectToken($"transform.rotation.{field}") is { } value && IsFinite(value) ? (double)value * (double)value : 0));

    static JObject Parse(string body)
    {
        try
        {
            return JObject.Parse(body);
        }
        catch (JsonException)
        {
            return null;
        }
    }
}
