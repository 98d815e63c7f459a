namespace Nowpose.Unity.Status
{
    /// <summary>Settings of a panel that follows its reader: lengths in metres, angles in degrees.</summary>
    readonly struct FollowSettings
    {
        /// <param name="distance">Distance from the head to the panel.</param>
        /// <param name="degreesBelow">Angle of the panel below the height of the eyes, as seen from the head.</param>
        /// <param name="turnDegrees">Maximum turn of the head to either side before the panel follows.</param>
        /// <param name="moveMetres">Maximum change of the head's distance or height before the panel follows.</param>
        /// <param name="glideSeconds">Time constant of the glide, in s: the time in which two thirds of the way are done.</param>
        public FollowSettings(float distance, float degreesBelow, float turnDegrees, float moveMetres, float glideSeconds)
        {
            Distance = distance;
            DegreesBelow = degreesBelow;
            TurnDegrees = turnDegrees;
            MoveMetres = moveMetres;
            GlideSeconds = glideSeconds;
        }

        public float Distance { get; }
        public float DegreesBelow { get; }
        public float TurnDegrees { get; }
        public float MoveMetres { get; }
        public float GlideSeconds { get; }
    }
}
