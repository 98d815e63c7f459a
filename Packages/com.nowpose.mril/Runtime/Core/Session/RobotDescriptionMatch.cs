namespace Nowpose.Session
{
    /// <summary>Whether the displayed robot is the one that the gateway describes.</summary>
    enum RobotDescriptionMatch
    {
        /// <summary>The gateway has not sent a valid description.</summary>
        Unknown,

        Same,

        /// <summary>The texts differ: other lengths, axes or names may cause a wrong pose of the displayed robot.</summary>
        Different,
    }
}
