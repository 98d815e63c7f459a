using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Creates messages with frames and signals, and converts received ones to text.</summary>
static class CellTexts
{
    public static FrameTransform Frame(string child, string parent = "world", double x = 0, ControlTime? stamp = null) =>
        new(stamp ?? Gateways.Start, parent, child, x, 0, 0, 0, 0, 0, 1);

    public static string Tf(params FrameTransform[] transforms) => Transforms(RosTopics.Tf, transforms);

    public static string TfStatic(params FrameTransform[] transforms) => Transforms(RosTopics.TfStatic, transforms);

    public static string SignalsText(params (string Name, double Value)[] values) => SignalsAt(Gateways.Start, values);

    public static string SignalsAt(ControlTime stamp, params (string Name, double Value)[] values) => RosbridgeWriter.Publish(
        RosTopics.Signals, new SignalsMessage(stamp, [.. values.Select(one => new SignalValue(one.Name, one.Value))]), RosTimeForm.Sec);

    /// <summary>Returns the frames of a message with their x coordinates: "box=0.5 belt=0".</summary>
    public static string Text(this TransformsMessage message) => string.Join(' ', Enumerable.Range(0, message.Count).Select(
        i => FormattableString.Invariant($"{message[i].Child}={message[i].X}")));

    /// <summary>Returns the signals of a message with their values: "grip=1 lamp=0".</summary>
    public static string Text(this SignalsMessage message) => string.Join(' ', Enumerable.Range(0, message.Count).Select(
        i => FormattableString.Invariant($"{message[i].Name}={message[i].Value}")));

    static string Transforms(string topic, FrameTransform[] transforms) =>
        RosbridgeWriter.Publish(topic, new TransformsMessage(transforms), RosTimeForm.Sec);
}
