using System.Linq;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    public class DisturbanceTests
    {
        // The first runs contain each kind of disturbance. The others are a study, which the run on Mono skips.
        const int FirstRuns = 12, Runs = 60;

        [Test]
        public void Tick_DisturbedCellNetworkAndClocks_CurrentPosesAreRightAndReturn() => Check(1, FirstRuns);

        [Test, Category("Study")]
        public void Tick_OtherDisturbances_CurrentPosesAreRightAndReturn() => Check(FirstRuns + 1, Runs - FirstRuns);

        static void Check(int firstSeed, int runs)
        {
            var faults = Enumerable.Range(firstSeed, runs)
                .SelectMany(seed => new DisturbedRun(seed).Run().Take(3).Select(fault => $"seed {seed}, {fault}"));

            Assert.That(string.Join("\n", faults), Is.Empty);
        }
    }
}
