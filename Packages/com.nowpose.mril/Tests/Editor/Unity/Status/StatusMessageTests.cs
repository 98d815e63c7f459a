using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity.Status;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Status
{
    /// <summary>Tests the message above the rows of the status panel.</summary>
    public class StatusMessageTests
    {
        static string MessageOf(SessionStatistics statistics)
        {
            var texts = new StatusTexts();
            texts.Update(statistics, null, "test", null);
            return texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
        }

        [Test]
        public void Update_GatewayReportsAnError_ShowsIt() =>
            Assert.That(MessageOf(new SessionStatistics { SampleLink = LinkStatus.ConnectedWith("the name is taken") }), Is.EqualTo("! the name is taken"));
    }
}
