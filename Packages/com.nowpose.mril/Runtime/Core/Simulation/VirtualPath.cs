using System;

namespace Nowpose.Simulation
{
    /// <summary>
    /// One direction of a network whose settings may change at run time. Draws the same number of random values for each packet, with any settings.
    /// </summary>
    sealed class VirtualPath
    {
        readonly Func<NetworkProfile, PathDelay> _newDelay;
        readonly Random _random;
        NetworkProfile _network;
        PathDelay _delay;

        public VirtualPath(Func<NetworkProfile, PathDelay> newDelay, int seed)
        {
            _newDelay = newDelay;
            _random = new Random(seed);
        }

        /// <summary>Sends a packet.</summary>
        /// <param name="took">Delay of the network.</param>
        /// <param name="jitter">Additional delay.</param>
        /// <returns>False if the packet is lost.</returns>
        public bool TrySend(in VirtualCellSettings settings, out TimeSpan took, out TimeSpan jitter)
        {
            if (_network != settings.Network)
            {
                _network = settings.Network;
                _delay = _newDelay(_network);
            }
            took = _delay.Next();
            jitter = new TimeSpan((long)(_random.NextDouble() * settings.Jitter.Ticks));
            return _random.NextDouble() >= settings.Loss;
        }
    }
}
