using Nowpose.Gateway.Security;
using Nowpose.Network;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Pairing;

/// <summary>
/// Serves the pairing page, which shows the pairing code and prints markers, and handles the requests of the page. Available to browsers on
/// this machine and to operators.
/// </summary>
/// <remarks>
/// Anyone who can open the page can pair a headset. On another machine, an operator first logs in on the operations page. Alternatives are a
/// tunnel to this machine, and the command "pair", which shows the code on a terminal.
/// </remarks>
/// <param name="html">The page; null if it was not built.</param>
sealed class PairingPage(GatewayOptions options, ShownCode shown, AccessControl accessControl, string html)
{
    readonly HtmlPage _page = new(html);

    /// <summary>Port of the sync server, set when the server has started.</summary>
    public int SyncPort { get; set; }

    /// <summary>Port of the WebSocket server, set when the server has started.</summary>
    public int WebSocketPort { get; set; }

    public bool IsBuilt => _page.IsBuilt;

    CertificatePin Pin => options.Certificate == null ? null : CertificatePin.Of(options.Certificate);

    /// <summary>Responds to GET /pair with the page.</summary>
    public async Task ShowAsync(HttpContext context)
    {
        if (await AdmitAsync(context)) await _page.SendAsync(context);
    }

    /// <summary>Responds to POST /pair/code with the current pairing code. The body {"renew": ""} requests a new code.</summary>
    public async Task SendCodeAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (request.ContainsKey("renew"))
        {
            shown.Discard();
            accessControl.Log(context, PairingServiceMessages.CodeRenewed);
        }

        var code = shown.Current(out var left);
        await SmallJson.AnswerAsync(context, new { text = code.Text, left_s = left.TotalSeconds, key = code.Pin?.Beginning ?? "" });
    }

    /// <summary>
    /// Handles POST /pair/cell. If the request has a name, the response contains the text of the marker's code for name, host, offset and size_mm.
    /// Otherwise, the response contains the default name, the possible hosts, and whether the gateway has a certificate pin.
    /// </summary>
    public async Task SendCellAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (!request.ContainsKey("name"))
            await SmallJson.AnswerAsync(context, new { name = options.Cell ?? "", hosts = Hosts(context), has_pin = Pin != null });
        else
            await AnswerCellAsync(context, request);
    }

    Task AnswerCellAsync(HttpContext context, Dictionary<string, string> request)
    {
        string Field(string name) => request.GetValueOrDefault(name, "").Trim();
        try
        {
            var offset = Field("offset");
            if (!MarkerOffset.TryReadNumber(Field("size_mm"), out var sizeMm) || sizeMm <= 0)
                throw new InputException(PairingServiceMessages.MarkerSize(Field("size_mm")));
            var code = new CellCode(
                Field("name"), Field("host"), Pin, offset.Length == 0 ? null : MarkerOffset.Parse(offset, "marker offset"), sizeMm / 1000,
                SyncPort, WebSocketPort);
            return SmallJson.AnswerAsync(context, new { text = code.Text });
        }
        catch (InputException fault)
        {
            return SmallJson.AnswerAsync(context, new { fault = fault.Message });
        }
    }

    string[] Hosts(HttpContext context)
    {
        // Without TLS, pairing is possible on this machine only.
        if (options.Certificate == null) return ["localhost"];
        var hosts = OwnHosts.Reachable(options.Bind);
        // Of several network cards, the headsets probably reach the one at which the browser opened the page.
        var opened = context.Request.Host.Host;
        if (!ConnectionSettings.IsLoopbackHost(opened.Trim('[', ']'))) hosts = hosts.Prepend(opened);
        return [.. hosts.Select(host => host.Trim('[', ']')).Distinct()];
    }

    async Task<bool> AdmitAsync(HttpContext context)
    {
        if (!await accessControl.AdmitOriginAsync(context)) return false;
        // Checks the host name against DNS rebinding: another site can make its own host name resolve to this machine and read the response.
        // Does not compare with the local address: rootless containers can receive all connections from their own address.
        if (AccessRule.IsFromHere(context) && accessControl.IsOwnHost(context)) return true;
        // An operator's login needs no host check, because browsers do not send its cookie or header under another host name.
        if (accessControl.IsOperator(context)) return true;
        await AccessControl.AnswerAsync(
            context, StatusCodes.Status403Forbidden,
            OwnHosts.IsLocalhostReachable(options.Bind) ? PairingServiceMessages.ThisMachineOnly : PairingServiceMessages.OperatorsOnly);
        return false;
    }
}
