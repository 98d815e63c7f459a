using Nowpose.Session.Hindcast;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class ReductionEstimateTests
    {
        /// <summary>The reference values are from published tables of Student's t-distribution.</summary>
        [TestCase(3, 3.182446)]
        [TestCase(4, 2.776445)]
        [TestCase(5, 2.570582)]
        [TestCase(10, 2.228139)]
        [TestCase(30, 2.042272)]
        [TestCase(120, 1.979930)]
        public void Student95_DegreesOfFreedom_IsTheTabulatedQuantile(int freedom, double expected)
        {
            Assert.That(ReductionEstimate.Student95(freedom), Is.EqualTo(expected).Within(0.15).Percent);
        }
    }
}
