using Nowpose.Gateway.Security;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Pairing;

/// <summary>Serves the requests to /pair and below it, if the gateway pairs headsets.</summary>
sealed class PairingRoutes
{
    const string CodePath = PairingLimits.Path + "/code", CellPath = PairingLimits.Path + "/cell";

    readonly PairingService _service;
    readonly bool _isOn;

    /// <param name="html">The HTML of the page; null if it was not built.</param>
    public PairingRoutes(GatewayOptions options, AccessControl accessControl, ConnectionCounters counters, Action<string> log, string html)
    {
        var shown = new ShownCode(options.Certificate == null ? null : CertificatePin.Of(options.Certificate), options.Time);
        _isOn = options.Headsets != null;
        _service = new PairingService(options, shown, accessControl, counters, log);
        Page = new PairingPage(options, shown, accessControl, html);
    }

    public PairingPage Page { get; }

    /// <summary>Handles the requests for pairing. Passes on all others.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        var request = context.Request;
        if (!_isOn || !request.Path.StartsWithSegments(PairingLimits.Path, StringComparison.Ordinal)) return next(context);
        var isPost = HttpMethods.IsPost(request.Method);
        return request.Path.Value switch
        {
            PairingLimits.Path when isPost => _service.ServeAsync(context),
            PairingLimits.Path when HttpMethods.IsGet(request.Method) => Page.ShowAsync(context),
            CodePath when isPost => Page.SendCodeAsync(context),
            CellPath when isPost => Page.SendCellAsync(context),
            PairingLimits.Path or CodePath or CellPath => AccessControl.RefuseMethodAsync(context, request.Path == PairingLimits.Path ? "GET, POST" : "POST"),
            _ => AccessControl.AnswerAsync(context, StatusCodes.Status404NotFound, $"{request.Path}: page not found"),
        };
    }
}
