namespace Nowpose.Session.Hindcast
{
    /// <summary>True position of a joint at one time; <c>default</c> is "not known".</summary>
    readonly struct TruthSample
    {
        public TruthSample(ControlTime at, double position)
        {
            IsKnown = true;
            At = at;
            Position = position;
        }

        public bool IsKnown { get; }
        public ControlTime At { get; }
        public double Position { get; }
    }
}
