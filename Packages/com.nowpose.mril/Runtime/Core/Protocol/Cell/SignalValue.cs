namespace Nowpose.Protocol.Cell
{
    /// <summary>The value of a signal of the plant.</summary>
    readonly struct SignalValue
    {
        /// <param name="value">See <see cref="Value"/>.</param>
        public SignalValue(string name, double value)
        {
            Name = name;
            Value = value;
        }

        public string Name { get; }

        /// <summary>Finite; 0 or 1 for a Boolean.</summary>
        public double Value { get; }
    }
}
