using System.Globalization;
using System.Net;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Finds the faults of the gateway's address and certificate, and of the files that determine who may connect.</summary>
static class AccessConditions
{
    /// <summary>Remaining validity below which a certificate is reported.</summary>
    static readonly TimeSpan CertificateNotice = TimeSpan.FromDays(30);

    public static IEnumerable<Condition> Of(GatewayOptions options) =>
        OfAddress(options.Bind).Concat(OfCertificate(options)).Concat(options.FileFaults.Select(OfFile));

    // The sockets stay open, so that clients can connect again when the address is back.
    static IEnumerable<Condition> OfAddress(IPAddress bind)
    {
        if (OwnHosts.IsOfThisMachine(bind)) yield break;
        yield return new("connection", bind.ToString(), EventTexts.NoAddress, EventTexts.NoClientReachesAddress, Level.Error, true)
        {
            Headline = EventTexts.AddressMissing(bind),
            Remedy = EventRemedies.Address,
        };
    }

    static Condition OfFile((string Path, string Fault) file) =>
        new("file", Path.GetFileName(file.Path), EventTexts.IsInvalid, file.Fault, Level.Warning) { Remedy = EventRemedies.File };

    static IEnumerable<Condition> OfCertificate(GatewayOptions options)
    {
        var left = options.CertificateExpires - options.Time.GetUtcNow().UtcDateTime;
        if (left > CertificateNotice || left == null) yield break;
        var day = options.CertificateExpires.Value.ToString("yyyy-MM-dd HH:mm 'UTC'", CultureInfo.InvariantCulture);
        const string Remedy = EventRemedies.Certificate;
        yield return left > TimeSpan.Zero
            ? new("certificate", EventTexts.OfTheGateway, EventTexts.Expires, EventTexts.ExpiresOn(day, Remedy), Level.Warning)
            {
                Headline = EventTexts.CertificateExpires,
            }
            : new("certificate", EventTexts.OfTheGateway, EventTexts.HasExpired, EventTexts.HeadsetsRefuse(day, Remedy), Level.Error, true)
            {
                Headline = EventTexts.CertificateExpired,
            };
    }
}
