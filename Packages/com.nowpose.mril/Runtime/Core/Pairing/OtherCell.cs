namespace Nowpose.Pairing
{
    /// <summary>Detects that the wearer is looking at a known cell that is not the cell in use.</summary>
    sealed class OtherCell
    {
        string _inView, _looked, _declined;
        bool _isUsedInView;
        HeadsetTime _since, _declinedSeen;

        /// <summary>Records that a marker of a known cell is in view.</summary>
        public void See(string cell, bool isUsed)
        {
            if (isUsed) _isUsedInView = true;
            else if (_inView == null || cell == _looked) _inView = cell;
        }

        /// <summary>Ends a frame.</summary>
        /// <returns>
        /// Name of another cell that the wearer has looked at for long enough and has not declined; null if there is none, or if the cell
        /// in use is also in view.
        /// </returns>
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

        /// <summary>Ignores a cell while it remains in view, and for some time after it was last seen.</summary>
        public void Decline(string cell, HeadsetTime now)
        {
            _declined = cell;
            _declinedSeen = now;
        }

        public void Reconsider() => _declined = null;
    }
}
