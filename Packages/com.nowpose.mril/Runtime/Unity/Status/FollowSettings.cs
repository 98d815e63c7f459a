namespace Nowpose.Unity.Status
{
    /// <summary>Settings of a panel that follows its reader. Lengths are in metres, angles in degrees.</summary>
    readonly struct FollowSettings
    {
        /// <param name="distance">Distance from the head to the panel.</param>
        /// <param name="degreesBelow">Angle below the horizontal at which the reader sees the panel.</param>
        /// <param name="turnDegrees">Maximum rotation of the head to either side before the panel follows.</param>
        /// <param name="moveMetres">Maximum change of the head's distance or height before the panel follows.</param>
        /// <param name="glideSeconds">Time constant of the glide in s. In this time, the panel moves through 63 % of its remaining distance.</param>
        public FollowSettings(float distance, float degreesBelow, float turnDegrees, float moveMetres, float glideSeconds) =>
            (Distance, DegreesBelow, TurnDegrees, MoveMetres, GlideSeconds) = (distance, degreesBelow, turnDegrees, moveMetres, glideSeconds);

        public float Distance { get; }
        public float DegreesBelow { get; }
        public float TurnDegrees { get; }
        public float MoveMetres { get; }
        public float GlideSeconds { get; }
    }
}
