using System.Linq;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    public class DisturbanceTests
    {
        const int Runs = 60;

        [Test]
        public void Tick_DisturbedCellNetworkAndClocks_CurrentPosesAreRightAndReturn()
        {
            var faults = Enumerable.Range(1, Runs).SelectMany(seed => new DisturbedRun(seed).Run().Take(3).Select(fault => $"seed {seed}, {fault}"));

            Assert.That(string.Join("\n", faults), Is.Empty);
        }
    }
}
