using System.Text;
using Newtonsoft.Json.Linq;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>
/// Reads the valid transforms or signals of a message on /tf, /tf_static or /signals that also contains invalid ones, for example a tracker's pose of an
/// object that it has lost. Not thread-safe.
/// </summary>
/// <remarks>Each transform or signal is read as a message of its own, so that the rules are those of <see cref="RosbridgeReader"/>.</remarks>
sealed class PartialCellMessage
{
    static readonly JsonNames Envelope = new("msg"), Transforms = new("transforms"), Signals = new("header", "name", "value");

    readonly RosbridgeReader _reader = new();

    /// <summary>Reads the valid parts of a rejected message.</summary>
    /// <param name="utf8">The complete message, which is JSON.</param>
    /// <param name="message">The envelope of the message; receives the valid transforms or signals.</param>
    /// <param name="leftOut">
    /// Receives the invalid transforms or signals. Receives none if the message as a whole is invalid, for example because it has too many.
    /// </param>
    /// <returns>Whether at least one transform or signal is valid.</returns>
    public bool TryRead(ReadOnlySpan<byte> utf8, RosbridgeMessage message, List<LeftOut> leftOut)
    {
        var isSignal = message.Topic == RosTopics.Signals;
        var parts = utf8.Length > ProtocolLimits.MessageBytes ? [] : isSignal ? SignalsIn(utf8) : TransformsIn(utf8);
        var names = parts.ConvertAll(InvalidCellMessage.NameIn);
        var (transforms, signals, known) = (new TransformsMessage(), (SignalsMessage)null, new HashSet<string>());
        for (var i = 0; i < parts.Count; i++)
        {
            var isTwice = names[i].Length > 0 && names.FindAll(name => name == names[i]).Count > 1;
            if (isTwice && !known.Add(names[i])) continue;
            var text = $"{{\"op\":\"publish\",\"topic\":\"{message.Topic}\",\"msg\":{parts[i]}}}";
            var isValid = _reader.TryRead(Encoding.UTF8.GetBytes(text), out var part, out var reason) && !isTwice;
            if (isTwice) reason = DropReason.DuplicateName;
            if (!isValid) leftOut.Add(new LeftOut(reason, names[i], InvalidCellMessage.Describe(parts[i], names[i], CellKinds.Of(message.Topic), reason)));
            else if (isSignal) (signals ??= new SignalsMessage(part.Signals.Stamp)).Add(part.Signals[0]);
            else transforms.Add(part.Transforms[0]);
        }

        message.Signals = signals;
        message.Transforms = transforms.Count > 0 ? transforms : null;
        return signals != null || transforms.Count > 0;
    }

    // Returns a body with one transform for each transform of the message.
    static List<string> TransformsIn(ReadOnlySpan<byte> utf8)
    {
        var json = BodyOf(utf8);
        var seen = 0;
        List<string> elements = [];
        json.BeginObject();
        while (json.NextField(Transforms, ref seen, out _)) elements = Elements(ref json);
        return json.Fault == DropReason.None && elements.Count <= ProtocolLimits.Frames ? elements.ConvertAll(one => $"{{\"transforms\":[{one}]}}") : [];
    }

    // Returns a body with one signal for each signal of the message.
    static List<string> SignalsIn(ReadOnlySpan<byte> utf8)
    {
        var json = BodyOf(utf8);
        var seen = 0;
        var header = "null";
        List<string> names = [], values = [];
        json.BeginObject();
        while (json.NextField(Signals, ref seen, out var field))
        {
            if (field == 0) header = Text(ref json);
            else if (field == 1) names = Elements(ref json);
            else values = Elements(ref json);
        }

        return json.Fault == DropReason.None && names.Count == values.Count && names.Count <= ProtocolLimits.Signals
            ? [.. names.Select((name, i) => $"{{\"header\":{header},\"name\":[{name}],\"value\":[{values[i]}]}}")] : [];
    }

    // Returns a reader at the start of the message's body.
    static JsonUtf8Reader BodyOf(ReadOnlySpan<byte> utf8)
    {
        var json = new JsonUtf8Reader(utf8, ProtocolLimits.Nesting);
        var seen = 0;
        json.BeginObject();
        json.NextField(Envelope, ref seen, out _);
        return json;
    }

    static List<string> Elements(ref JsonUtf8Reader json)
    {
        List<string> elements = [];
        json.BeginArray();
        while (json.NextElement()) elements.Add(Text(ref json));
        return elements;
    }

    static string Text(ref JsonUtf8Reader json)
    {
        var start = json.Position;
        json.Skip();
        return Encoding.UTF8.GetString(json.Since(start));
    }
}
