using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Simulated markers whose base is locked.</summary>
    static class LockedMarkers
    {
        /// <summary>Runs until all markers in view have locked the base, then for one more second.</summary>
        public static SimulatedMarkers Locked(SimulatedMarkers cell)
        {
            Assert.That(cell.RunUntilLocked(3), Is.Not.Null);
            cell.Run(1);
            return cell;
        }

        /// <summary>Creates a locked base with one marker that is seen with noise.</summary>
        public static SimulatedMarkers NoisyOne(int seed = 1)
        {
            var cell = SimulatedMarkers.One(seed, 0.3);
            cell.Noisy();
            return Locked(cell);
        }
    }
}
