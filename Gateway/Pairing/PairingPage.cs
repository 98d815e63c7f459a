using System.Net;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Pairing;

/// <summary>The page that shows the code and prints markers, with its requests. For browsers on this machine, and for operators' browsers.</summary>
/// <remarks>
/// Anyone who can open the page can pair a headset. From other machines, an operator logs in on the operations page first. Alternatively,
/// the page is opened through a tunnel by a user of this machine, or the verb "pair" shows the code on a terminal.
/// </remarks>
/// <param name="html">Null if the page was not built.</param>
sealed class PairingPage(GatewayOptions options, ShownCode shown, AccessControl accessControl, string html)
{
    readonly HtmlPage _page = new(html);

    /// <summary>Ports of both servers, once they are known.</summary>
    public int SyncPort { get; set; }

    /// <inheritdoc cref="SyncPort"/>
    public int WebSocketPort { get; set; }

    public bool IsBuilt => _page.IsBuilt;

    CertificatePin Pin => options.Certificate == null ? null : CertificatePin.Of(options.Certificate);

    /// <summary>GET /pair.</summary>
    public async Task ShowAsync(HttpContext context)
    {
        if (await AdmitAsync(context)) await _page.SendAsync(context);
    }

    /// <summary>POST /pair/code: {"renew": ""} requests a new code.</summary>
    public async Task SendCodeAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (request.ContainsKey("renew")) shown.Discard();
        var code = shown.Current(out var left);
        await SmallJson.AnswerAsync(context, new { text = code.Text, left_s = left.TotalSeconds, key = code.Pin?.Beginning ?? "" });
    }

    /// <summary>POST /pair/cell: gets the marker's code for name, host, offset and size_mm; without them, the default values.</summary>
    public async Task SendCellAsync(HttpContext context)
    {
        if (!await AdmitAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (!request.ContainsKey("name"))
            await SmallJson.AnswerAsync(context, new { name = options.Cell ?? "", hosts = Hosts(), has_pin = Pin != null });
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

    // A gateway without TLS serves this machine only.
    string[] Hosts() => options.Certificate == null
        ? ["localhost"] : [.. OwnHosts.Reachable(options.Bind).Select(host => host.Trim('[', ']'))];

    async Task<bool> AdmitAsync(HttpContext context)
    {
        if (!await accessControl.AdmitOriginAsync(context)) return false;
        // A page whose name was made to resolve to this address (DNS rebinding) could read the answer. It sends its own host name.
        if (IsFromThisMachine(context.Connection) && accessControl.IsOwnHost(context)) return true;
        // An operator's cookie or header is not sent with such a name.
        if (accessControl.IsOperator(context)) return true;
        await AccessControl.AnswerAsync(
            context, StatusCodes.Status403Forbidden,
            PairingServiceMessages.ThisMachineOnly);
        return false;
    }

    // Answers to an address of this machine cannot reach any other machine.
    static bool IsFromThisMachine(ConnectionInfo connection) =>
        IPAddress.IsLoopback(connection.RemoteIpAddress) || connection.RemoteIpAddress.Equals(connection.LocalIpAddress);
}
