using System;

namespace Nowpose.Anchoring
{
    /// <summary>Conditions for using a sighting, for locking the base, and for detecting that a marker has moved.</summary>
    sealed class AnchoringSettings
    {
        /// <param name="settleMs">Minimum observation time of the markers before the base is locked.</param>
        /// <param name="oldestMs">Maximum age of a sighting that counts as current.</param>
        /// <param name="farthestMetres">Maximum distance of a marker from the viewer's head.</param>
        /// <param name="maxObliqueDegrees">Maximum angle between the normal of the print and the line to the viewer's head.</param>
        /// <param name="lockErrorMetres">Maximum estimated error (root mean square) of each marker's mean position for a lock.</param>
        /// <param name="lockErrorDegrees">Maximum estimated error of each marker's mean angle for a lock.</param>
        /// <param name="toleranceMetres">Distance of a marker from its position at the lock above which the marker counts as moved.</param>
        /// <param name="toleranceDegrees">Change of a marker's angle since the lock above which the marker counts as moved.</param>
        /// <param name="easeMs">
        /// Duration over which a changed lock is blended in; 2 % of the change remains at its end. 0 applies a change immediately.
        /// </param>
        /// <exception cref="InputException">A number is out of range.</exception>
        public AnchoringSettings(
            double settleMs = 1850, double oldestMs = 2000, double farthestMetres = 2.5, double maxObliqueDegrees = 60,
            double lockErrorMetres = 0.001, double lockErrorDegrees = 0.25,
            double toleranceMetres = 0.005, double toleranceDegrees = 0.5, double easeMs = 800)
        {
            Settle = SettingRange.RequireMs(settleMs, 100, 60_000, "settle");
            Oldest = SettingRange.RequireMs(oldestMs, 20, 10_000, "maximum age");
            MaxDistanceMetres = SettingRange.Require(farthestMetres, 0.1, 20, "maximum distance", "m");
            MaxObliqueRadians = Radians(SettingRange.Require(maxObliqueDegrees, 10, 89, "maximum viewing angle", "°"));
            LockErrorMetres = SettingRange.Require(lockErrorMetres, 0.0001, 0.1, "lock error", "m");
            LockErrorRadians = Radians(SettingRange.Require(lockErrorDegrees, 0.01, 10, "lock error", "°"));
            ToleranceMetres = SettingRange.Require(toleranceMetres, 0.001, 1, "tolerance", "m");
            ToleranceRadians = Radians(SettingRange.Require(toleranceDegrees, 0.1, 45, "tolerance", "°"));
            Ease = SettingRange.RequireMs(easeMs, 0, 10_000, "ease");
        }

        public TimeSpan Settle { get; }
        public TimeSpan Oldest { get; }
        public double MaxDistanceMetres { get; }
        public double MaxObliqueRadians { get; }
        public double LockErrorMetres { get; }
        public double LockErrorRadians { get; }
        public double ToleranceMetres { get; }
        public double ToleranceRadians { get; }
        public TimeSpan Ease { get; }

        static double Radians(double degrees) => degrees * Math.PI / 180;
    }
}
