using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Rosbridge;
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
}
