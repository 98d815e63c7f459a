namespace Nowpose.Session.Hindcast
{
    /// <summary>Sums over frames, from which root mean squares are computed.</summary>
    struct ErrorSums
    {
        public int Count;
        public double Displayed, Held, Truth, Clock;

        public void Add(in ErrorSample sample)
        {
            Count++;
            Displayed += sample.DisplayedSquared;
            Held += sample.HeldSquared;
            Truth += sample.TruthSquared;
            Clock += sample.ClockSquared;
        }

        public void Add(in ErrorSums sums)
        {
            Count += sums.Count;
            Displayed += sums.Displayed;
            Held += sums.Held;
            Truth += sums.Truth;
            Clock += sums.Clock;
        }
    }
}
