namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases that differ only in a number or a few bytes. Each section is one row of the document's table.</summary>
/// <param name="Number">Numbers in the suite, for example "2.7–2.9".</param>
/// <param name="What">Description of the frames that are sent.</param>
/// <param name="Note">Difference from the suite, and the reason for it; empty if there is none.</param>
sealed record AutobahnSection(string Number, string What, string Note, AutobahnCase[] Cases);
