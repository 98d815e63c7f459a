namespace Nowpose.Gateway;

/// <summary>Adds to every answer what tells browsers to take it for nothing else, and to show it in no other site's page.</summary>
static class SecurityHeaders
{
    /// <summary>Of an answer that is no page: nothing in it is run or loaded.</summary>
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
