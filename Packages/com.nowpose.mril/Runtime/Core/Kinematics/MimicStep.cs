namespace Nowpose.Kinematics
{
    /// <summary>One mimic joint with indices instead of names. In a model, masters precede their followers.</summary>
    readonly struct MimicStep
    {
        public MimicStep(int joint, int master, double multiplier, double offset)
        {
            Joint = joint;
            Master = master;
            Multiplier = multiplier;
            Offset = offset;
        }

        public int Joint { get; }
        public int Master { get; }
        public double Multiplier { get; }
        public double Offset { get; }
    }
}
