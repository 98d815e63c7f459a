using System;
using MathNet.Numerics.Distributions;

namespace Nowpose.Simulation
{
    /// <summary>Generates the delays of consecutive packets in one direction of a connection. Seeded; not thread-safe.</summary>
    sealed class PathDelay
    {
        const double SpikeContinuation = 0.3;

        readonly NetworkProfile _profile;
        readonly double _spikeChance;
        readonly Random _random;
        bool _inSpike;

        internal PathDelay(NetworkProfile profile, double spikeChance, int seed)
        {
            _profile = profile;
            _spikeChance = spikeChance;
            _random = new Random(seed);
        }

        public TimeSpan Next()
        {
            // MathNet's gamma distribution has a rate parameter; the profile has a scale parameter.
            var ms = _profile.BaseMs + Gamma.Sample(_random, _profile.GammaShape, 1 / _profile.GammaScaleMs);
            _inSpike = _random.NextDouble() < (_inSpike ? SpikeContinuation : _spikeChance);
            if (_inSpike)
                ms += _profile.MinSpikeMs + (_profile.MaxSpikeMs - _profile.MinSpikeMs) * _random.NextDouble();
            return ClockTicks.Span(ms / 1000);
        }
    }
}
