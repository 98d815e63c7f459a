using NUnit.Framework;

namespace Nowpose.Tests
{
    public class SimulatedDisplayTests
    {
        static double VisualisationMs(double renderMs)
        {
            var display = new SimulatedDisplay(1) { Scatter = 0, SpikeChance = 0 };
            for (var frame = 0; frame < 50; frame++) display.Next(SimulatedDisplay.LoadOf(renderMs));
            return display.Next(SimulatedDisplay.LoadOf(renderMs)).VisualisationMs;
        }

        [Test]
        public void Next_UpToTheTrueLimit_HasConstantLatencyAndBeyondALongerOne()
        {
            var least = VisualisationMs(4);

            Assert.That(VisualisationMs(SimulatedDisplay.TrueLimitMs - 0.01), Is.EqualTo(least).Within(1e-6));
            Assert.That(VisualisationMs(SimulatedDisplay.TrueLimitMs + 0.01), Is.EqualTo(least + SimulatedDisplay.RefreshMs).Within(1e-6));
            Assert.That(VisualisationMs(18), Is.GreaterThan(least + SimulatedDisplay.RefreshMs), "the queue is full");
            Assert.That(SimulatedDisplay.TrueLimitMs, Is.EqualTo(15.17).Within(0.01));
        }
    }
}
