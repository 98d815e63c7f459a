namespace Nowpose.Gateway;

/// <summary>Adds headers to every answer that prevent browsers from guessing content types and other sites from framing a page.</summary>
static class SecurityHeaders
{
    /// <summary>Content security policy for answers that are not pages: a browser must not run or load anything because of them.</summary>
    const string NoPage = "default-src 'none'; frame-ancestors 'none'";

    public static Task AddAsync(HttpContext context, RequestDelegate next)
    {
        var headers = context.Response.Headers;
        headers.XContentTypeOptions = "nosniff";
        headers["Referrer-Policy"] = "no-referrer";
        headers.XFrameOptions = "DENY";
        headers.ContentSecurityPolicy = NoPage;
        return next(context);
    }
}
