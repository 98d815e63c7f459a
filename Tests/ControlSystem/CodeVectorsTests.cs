using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.ControlSystem;

public class CodeVectorsTests
{
    [Test]
    public void Draw_ReferenceValues_LightsTheExpectedCells()
    {
        var cells = new bool[TimestampCode.CellCount];

        Assert.That(CodeVectors.Read().Select(vector => vector.Kind).Distinct(), Is.EquivalentTo(new[] { "control", "headset" }));
        foreach (var vector in CodeVectors.Read())
        {
            TimestampCode.Draw(vector.ValueMs, vector.Kind == "control" ? CodeKind.Control : CodeKind.Headset, cells);

            var lit = cells.Chunk(8).Select(row => row.Aggregate(0, (bits, isLit) => bits << 1 | (isLit ? 1 : 0))).ToArray();
            Assert.That(lit, Is.EqualTo(vector.Rows), $"{vector.ValueMs} ms, {vector.Kind}");
        }
    }
}
