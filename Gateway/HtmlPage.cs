using System.Text;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway;

/// <summary>A page of Web, which may be missing where the gateway was built.</summary>
/// <param name="html">Null where it was not built.</param>
sealed class HtmlPage(string html)
{
    /// <summary>What to do where the page is missing.</summary>
    public const string Missing =
        "the page is missing, for this gateway was built without Node.js; install Node.js 20 or newer with npm and build again";

    readonly byte[] _page = html == null ? null : Encoding.UTF8.GetBytes(html);

    public bool IsBuilt => _page != null;

    public Task SendAsync(HttpContext context)
    {
        if (!IsBuilt) return Door.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, Missing);
        var response = context.Response;
        response.ContentType = "text/html; charset=utf-8";
        response.ContentLength = _page.Length;
        response.Headers.CacheControl = "no-store";
        // Nobody had to show a token: it must not hold one of the places of those that did.
        response.Headers.Connection = "close";
        // Another site that frames it could have the visitor click on it, or read along.
        response.Headers.XFrameOptions = "DENY";
        return response.Body.WriteAsync(_page).AsTask();
    }
}
