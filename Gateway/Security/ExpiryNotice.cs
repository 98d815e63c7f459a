using System.Globalization;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Security;

/// <summary>Logs once when a certificate will expire soon, when it has expired, and when it was renewed.</summary>
sealed class ExpiryNotice(Action<string> log)
{
    static readonly TimeSpan Ahead = TimeSpan.FromDays(30);

    bool _isClose, _isOver;

    /// <summary>Checks the certificate. Called periodically.</summary>
    /// <param name="expires">Expiry of the certificate, local time; null without a certificate.</param>
    /// <param name="now">The local time.</param>
    public void Look(DateTime? expires, DateTime now)
    {
        if (expires is not { } end) return;
        var (isClose, isOver) = (end - now < Ahead, end < now);
        var day = end.ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture);
        if (isOver && !_isOver)
            log(KeyFileMessages.Expired(day));
        else if (isClose && !_isClose)
            log(KeyFileMessages.Expires(day, (end - now).TotalDays));
        else if (!isClose && _isClose)
            log(KeyFileMessages.Renewed(day));
        (_isClose, _isOver) = (isClose, isOver);
    }
}
