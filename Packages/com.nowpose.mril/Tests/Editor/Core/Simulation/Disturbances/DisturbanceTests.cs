using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    public class DisturbanceTests
    {
        const int Runs = 60;

        // Together, these runs contain each kind of disturbance. The others are a study, which the run on Mono skips.
        static readonly int[] FirstSeeds = { 1, 2, 4, 8, 9, 11 };

        [Test]
        public void Tick_DisturbedCellNetworkAndClocks_CurrentPosesAreRightAndReturn() => Check(FirstSeeds);

        [Test]
        public void FirstSeeds_All_ContainEachKind()
        {
            var kinds = FirstSeeds.SelectMany(seed => Disturbance.Some(new Random(seed))).ToArray();

            Assert.That(typeof(DisturbanceKind).GetEnumValues().Cast<DisturbanceKind>().Where(kind => !kinds.Any(one => one.Is(kind))), Is.Empty);
        }

        [Test, Category("Study")]
        public void Tick_OtherDisturbances_CurrentPosesAreRightAndReturn() => Check(Enumerable.Range(1, Runs).Except(FirstSeeds));

        static void Check(IEnumerable<int> seeds)
        {
            var faults = seeds.SelectMany(seed => new DisturbedRun(seed).Run().Take(3).Select(fault => $"seed {seed}, {fault}"));

            Assert.That(string.Join("\n", faults), Is.Empty);
        }
    }
}
