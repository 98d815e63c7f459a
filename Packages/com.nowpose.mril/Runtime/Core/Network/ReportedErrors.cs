using System;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Status of an open connection with the error that the server reports over it. Not thread-safe.</summary>
    /// <remarks>
    /// An error lasts until the server has not repeated it for five seconds, because the server does not report that its cause has ended. Until then,
    /// other errors are ignored: the status would otherwise alternate between the errors of two topics.
    /// </remarks>
    sealed class ReportedErrors
    {
        const int MaxLength = 300;

        static readonly TimeSpan Duration = ClockTicks.Span(5);

        LinkStatus _status = LinkStatus.Connected;
        string _text;
        HeadsetTime _newest;

        /// <summary>Returns the status at the arrival of a message.</summary>
        public LinkStatus StatusAt(HeadsetTime now)
        {
            if (_text == null || now - _newest <= Duration) return _status;
            _text = null;
            return _status = LinkStatus.Connected;
        }

        /// <summary>Adds a status message of the server. Only errors change the status of the connection.</summary>
        /// <returns>The status after the message.</returns>
        public LinkStatus Add(RosbridgeMessage message, HeadsetTime arrival)
        {
            if (message.Level != "error" || (StatusAt(arrival).Warning != null && message.Text != _text)) return _status;
            _newest = arrival;
            if (message.Text == _text) return _status;
            _text = message.Text;
            return _status = LinkStatus.ConnectedWith(ConnectionMessages.Reported(InputException.OneLine(_text, MaxLength)));
        }
    }
}
