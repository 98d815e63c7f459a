using System;
using System.Globalization;
using Nowpose.Unity.Messages;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// States since when a part has not been current: the local time of day, or the date if it was another day. Creates a new string only when this
    /// time changes.
    /// </summary>
    sealed class SinceText
    {
        static readonly TimeSpan Tolerance = TimeSpan.FromSeconds(1);

        DateTime _since, _day;
        string _text = "";

        /// <param name="age">Time for which the part has not been current; null while unknown.</param>
        /// <param name="now">Local time.</param>
        /// <returns>Empty while the age is unknown.</returns>
        public string Of(TimeSpan? age, DateTime now)
        {
            if (!(age is TimeSpan length)) return _text = "";
            var since = length > TimeSpan.Zero ? now - length : now;
            // The difference of two clocks that are read at different moments varies, so the time has a tolerance.
            if (_text.Length > 0 && (since - _since).Duration() <= Tolerance && now.Date == _day) return _text;
            (_since, _day) = (since, now.Date);
            return _text = StatusMessages.Since(since.ToString(since.Date == _day ? "HH:mm:ss" : "MMM d", CultureInfo.InvariantCulture));
        }
    }
}
