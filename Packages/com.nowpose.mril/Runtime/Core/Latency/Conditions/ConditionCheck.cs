using System;
using System.Collections.Generic;

namespace Nowpose.Latency.Conditions
{
    /// <summary>Compares the conditions of a running session with the conditions of the profile in use.</summary>
    /// <remarks>Not thread-safe. Allocates only when a condition or the profile changes.</remarks>
    sealed class ConditionCheck
    {
        readonly bool _rewritesBeforeRender;
        DisplayConditions _device = DisplayConditions.Unknown;
        ReprojectionMode _reprojection;
        LatencyProfile _profile;
        IReadOnlyList<ConditionMismatch> _mismatches = Array.Empty<ConditionMismatch>();

        public ConditionCheck(bool rewritesBeforeRender)
        {
            _rewritesBeforeRender = rewritesBeforeRender;
            Update();
        }

        /// <summary>Conditions of the device, combined with the conditions of the session.</summary>
        public DisplayConditions Conditions { get; private set; }

        public ReprojectionMode Reprojection
        {
            get => _reprojection;
            set
            {
                if (value == _reprojection) return;
                _reprojection = value;
                Update();
            }
        }

        /// <param name="device">Conditions that the device reports.</param>
        public void Report(DisplayConditions device)
        {
            if (_device.Equals(device)) return;
            _device = device;
            Update();
        }

        /// <param name="profile">The profile in use; null if no profile is in use.</param>
        public IReadOnlyList<ConditionMismatch> MismatchesOf(LatencyProfile profile)
        {
            if (profile != _profile) Compare(profile);
            return _mismatches;
        }

        void Update()
        {
            Conditions = new DisplayConditions(rewritesBeforeRender: _rewritesBeforeRender, reprojection: _reprojection).Or(_device);
            Compare(_profile);
        }

        void Compare(LatencyProfile profile)
        {
            _profile = profile;
            _mismatches = profile?.MismatchesWith(Conditions) ?? Array.Empty<ConditionMismatch>();
        }
    }
}
