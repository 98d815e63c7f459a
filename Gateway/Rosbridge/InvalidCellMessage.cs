using Newtonsoft.Json.Linq;
using Nowpose.Frames;
using Nowpose.Gateway.Hub;
using static Nowpose.Frames.InvalidTransform;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Describes an invalid transform or signal with its value. The text is the body of a message with only this transform or signal.</summary>
static class InvalidCellMessage
{
    /// <summary>
    /// Describes the fault, for example "frame box has a transform.rotation with the norm 1.02; it must be 1 ± 0.001; normalise it".
    /// </summary>
    /// <param name="name">Name of the frame or signal; empty if unknown.</param>
    /// <param name="kind"><see cref="CellKinds.Frame"/> or <see cref="CellKinds.Signal"/>.</param>
    public static string Describe(string body, string name, string kind, DropReason reason)
    {
        var what = $"{kind} {(name.Length == 0 ? CellMessageFaults.NoName : InputException.OneLine(name, ProtocolLimits.NameLength))}";
        var trouble = kind == CellKinds.Signal ? OfSignal(body, reason) : OfTransform(body, reason);
        return trouble == null ? $"{what}: {DropMessages.Of(reason)}" : $"{what} {trouble}";
    }

    static string OfTransform(string body, DropReason reason) => reason == DropReason.StampZero ? CellMessageFaults.StampZero
        : Parse(body)?.SelectToken("transforms[0]") is JObject transform ? ProblemOf(transform, reason) : null;

    static string OfSignal(string body, DropReason reason) => reason switch
    {
        DropReason.DuplicateName => CellMessageFaults.Twice,
        DropReason.NotFinite => CellMessageFaults.Has("value", Value(body) is { } value ? Shown(value) : ""),
        DropReason.WrongType when Value(body) is { Type: not (JTokenType.Integer or JTokenType.Float) } value =>
            CellMessageFaults.NotANumber(Shown(value)),
        _ => null,
    };

    static JToken Value(string body) => Parse(body)?.SelectToken("value[0]");
}
