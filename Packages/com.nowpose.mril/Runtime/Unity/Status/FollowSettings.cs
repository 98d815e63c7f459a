namespace Nowpose.Unity.Status
{
    /// <summary>How a panel follows its reader: lengths in metres, angles in degrees.</summary>
    readonly struct FollowSettings
    {
        /// <param name="distance">From the head to the panel.</param>
        /// <param name="degreesBelow">Of the panel below the height of the eyes, as seen from there.</param>
        /// <param name="turnDegrees">The head may turn so far to either side before the panel follows.</param>
        /// <param name="moveMetres">The head may come so much nearer, go farther, rise or sink.</param>
        /// <param name="glideSeconds">In this time two thirds of the way are done.</param>
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
