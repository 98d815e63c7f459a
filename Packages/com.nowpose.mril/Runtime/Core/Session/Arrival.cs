namespace Nowpose.Session
{
    /// <summary>A message with its arrival time.</summary>
    readonly struct Arrival<T>
    {
        public Arrival(T message, HeadsetTime at) => (Message, At) = (message, at);

        public T Message { get; }

        /// <summary>Headset time at which the last byte of the message was read.</summary>
        public HeadsetTime At { get; }
    }
}
