using System;

namespace Nowpose.Anchoring
{
    /// <summary>Which sightings of markers count, when a base is locked by them, and when a marker is said to have moved.</summary>
    sealed class AnchoringSettings
    {
        /// <param name="settleMs">How long markers are looked at, at least, before the base is locked.</param>
        /// <param name="oldestMs">A marker that was seen longer ago is not taken for seen now.</param>
        /// <param name="farthestMetres">From the viewer's head.</param>
        /// <param name="mostObliqueDegrees">Between what stands out of the print and the line to the viewer's head.</param>
        /// <param name="lockErrorMetres">Root mean square by which each marker's mean may probably be off, for a lock.</param>
        /// <param name="lockErrorDegrees">The same of its angle.</param>
        /// <param name="toleranceMetres">A marker that is farther from where it was when the base was locked has moved.</param>
        /// <param name="toleranceDegrees">The same of its angle.</param>
        /// <param name="easeMs">In which a changed lock is eased over, but for 2 % of the change; 0 for at once.</param>
        /// <exception cref="InputException">A number is out of range.</exception>
        public AnchoringSettings(
            double settleMs = 1850, double oldestMs = 400, double farthestMetres = 2.5, double mostObliqueDegrees = 60,
            double lockErrorMetres = 0.001, double lockErrorDegrees = 0.25,
            double toleranceMetres = 0.005, double toleranceDegrees = 0.5, double easeMs = 800)
        {
            Settle = SettingRange.RequireMs(settleMs, 100, 60_000, "settle");
            Oldest = SettingRange.RequireMs(oldestMs, 20, 10_000, "oldest");
            FarthestMetres = SettingRange.Require(farthestMetres, 0.1, 20, "farthest", "m");
            MostObliqueRadians = Radians(SettingRange.Require(mostObliqueDegrees, 10, 89, "most oblique", "°"));
            LockErrorMetres = SettingRange.Require(lockErrorMetres, 0.0001, 0.1, "lock error", "m");
            LockErrorRadians = Radians(SettingRange.Require(lockErrorDegrees, 0.01, 10, "lock error", "°"));
            ToleranceMetres = SettingRange.Require(toleranceMetres, 0.001, 1, "tolerance", "m");
            ToleranceRadians = Radians(SettingRange.Require(toleranceDegrees, 0.1, 45, "tolerance", "°"));
            Ease = SettingRange.RequireMs(easeMs, 0, 10_000, "ease");
        }

        public TimeSpan Settle { get; }
        public TimeSpan Oldest { get; }
        public double FarthestMetres { get; }
        public double MostObliqueRadians { get; }
        public double LockErrorMetres { get; }
        public double LockErrorRadians { get; }
        public double ToleranceMetres { get; }
        public double ToleranceRadians { get; }
        public TimeSpan Ease { get; }

        static double Radians(double degrees) => degrees * Math.PI / 180;
    }
}
