namespace Nowpose.Pairing
{
    /// <summary>Which known cell other than the one in use the wearer evidently looks at.</summary>
    sealed class OtherCell
    {
        string _inView, _looked, _declined;
        bool _isUsedInView;
        HeadsetTime _since, _declinedSeen;

        /// <summary>A marker of a known cell is in view.</summary>
        public void See(string cell, bool isUsed)
        {
            if (isUsed) _isUsedInView = true;
            else if (_inView == null || cell == _looked) _inView = cell;
        }

        /// <summary>Closes a frame.</summary>
        /// <returns>Null for none: of several robots in view the one in use stays.</returns>
        public string Wanted(HeadsetTime now)
        {
            var other = _isUsedInView ? null : _inView;
            if (other != _looked) _since = now;
            _looked = other;
            if (_declined != null && _inView == _declined) _declinedSeen = now;
            else if (_declined != null && now - _declinedSeen > PairingLimits.OtherDeclined) _declined = null;
            _isUsedInView = false;
            _inView = null;
            return other != null && other != _declined && now - _since >= PairingLimits.LookAtOther ? other : null;
        }

        /// <summary>Not wanted as long as it goes on being in view, and a while after.</summary>
        public void Decline(string cell, HeadsetTime now)
        {
            _declined = cell;
            _declinedSeen = now;
        }

        public void Reconsider() => _declined = null;
    }
}
