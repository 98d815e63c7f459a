namespace Nowpose.Session
{
    /// <summary>The error of one joint between base and tool.</summary>
    public readonly struct JointError
    {
        public JointError(string joint, DisplayedError? error)
        {
            Joint = joint;
            Error = error;
        }

        /// <summary>Name of the joint in the URDF.</summary>
        public string Joint { get; }

        /// <summary>Error in rad, or in m for a prismatic joint; null while unknown.</summary>
        public DisplayedError? Error { get; }
    }
}
