using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>Estimated pose of a marker, with its estimated error.</summary>
    readonly struct MarkerEstimate
    {
        /// <summary>
        /// Standard deviation of a position along an axis, m, that does not decrease with the number of sightings. It covers the error of
        /// the configured position and the unevenness of the print.
        /// </summary>
        const double PlacedMetres = 0.00025;

        /// <summary>Standard error of the angle of a mounted print about an axis, rad. It is used if the other markers provide no estimate.</summary>
        public const double PlacedRadians = 0.5 * System.Math.PI / 180;

        /// <param name="inBase">Configured pose in the base frame.</param>
        /// <param name="mean">Mean of the sightings, in the room frame.</param>
        /// <param name="spreadMetres">Root mean square distance of the sightings from their mean.</param>
        /// <param name="spreadRadians">Root mean square angle between the sightings and their mean.</param>
        public MarkerEstimate(
            in RigidTransform inBase, in RigidTransform mean, double errorMetres, double errorRadians, double spreadMetres = 0, double spreadRadians = 0)
        {
            InBase = inBase;
            Mean = mean;
            ErrorMetres = errorMetres;
            ErrorRadians = errorRadians;
            SpreadMetres = spreadMetres;
            SpreadRadians = spreadRadians;
        }

        public RigidTransform InBase { get; }
        public RigidTransform Mean { get; }

        /// <summary>Estimated error of the mean's position, root mean square, m.</summary>
        public double ErrorMetres { get; }

        public double ErrorRadians { get; }

        public double SpreadMetres { get; }
        public double SpreadRadians { get; }

        public double PositionWeight => 1 / (ErrorMetres * ErrorMetres / 3 + PlacedMetres * PlacedMetres);

        /// <summary>Variance of the mean's rotation about an axis, rad², which decreases with the number of sightings.</summary>
        public double RotationVariance => ErrorRadians * ErrorRadians / 3;

        /// <param name="placedVariance">Variance of the angle about an axis that does not decrease with the number of sightings, rad².</param>
        public double RotationWeight(double placedVariance) => 1 / (RotationVariance + placedVariance);

        /// <summary>Returns the estimate with its mean transformed by <paramref name="room"/>.</summary>
        public MarkerEstimate From(in RigidTransform room) =>
            new MarkerEstimate(InBase, room * Mean, ErrorMetres, ErrorRadians, SpreadMetres, SpreadRadians);
    }
}
