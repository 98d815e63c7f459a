namespace Nowpose.Session
{
    /// <summary>Whether the robot that is displayed is the one the gateway describes.</summary>
    enum RobotDescriptionMatch
    {
        /// <summary>The gateway has sent no description that can be read.</summary>
        Unknown,

        Same,

        /// <summary>Another text: other lengths, axes or names may put the displayed robot beside the real one.</summary>
        Different,
    }
}
