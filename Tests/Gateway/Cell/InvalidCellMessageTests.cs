using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Messages;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Cell;

public class InvalidCellMessageTests
{
    static string Describe(string name, string value) =>
        InvalidCellMessage.Describe($"{{\"name\":[{name}],\"value\":[{value}]}}", "grip", CellKinds.Signal, DropReason.WrongType);

    [TestCase("true")]
    [TestCase("\"on\"")]
    public void Describe_ValueOfASignalIsNotANumber_NamesTheValue(string value) =>
        Assert.That(Describe("\"grip\"", value), Is.EqualTo("signal grip " + CellMessageFaults.NotANumber(value)));

    [TestCase("1")]
    [TestCase("0.5")]
    public void Describe_AnotherFieldHasTheWrongType_DoesNotNameTheValue(string value) =>
        Assert.That(Describe("3", value), Is.EqualTo("signal grip: " + DropMessages.Of(DropReason.WrongType)));

    [Test]
    public void Describe_FieldOfAFrameIsInvalid_NamesTheFieldAndTheAllowedValues()
    {
        static string Of(string x, DropReason reason) => InvalidCellMessage.Describe(
            "{\"transforms\":[{\"child_frame_id\":\"box\",\"transform\":{\"translation\":{\"x\":" + x + "}}}]}", "box", CellKinds.Frame, reason);
        static string Wrong(string value, string allowed) => "frame box " + FrameMessages.WrongField("transform.translation.x", value, allowed);

        Assert.That(Of("NaN", DropReason.NotFinite), Is.EqualTo(Wrong("NaN", FrameMessages.FiniteNumber)));
        Assert.That(Of("2e6", DropReason.OutOfRange), Is.EqualTo(Wrong("2000000", FrameMessages.Coordinate(1e6))));
        Assert.That(Of("\"2\"", DropReason.WrongType), Is.EqualTo(Wrong("\"2\"", FrameMessages.FiniteNumber)));
        Assert.That(Of("2", DropReason.MissingField), Is.EqualTo("frame box " + FrameMessages.NoField("header")));
    }
}
